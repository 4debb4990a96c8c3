# Intervals of a proportion: prop.test (Wilson, with and without continuity correction), binom.test
# (Clopper & Pearson), qbeta (Jeffreys), and Agresti & Coull's as they define it.
source("common/reading.R")

one_case <- function(k, n, level) {
  # prop.test corrects less than 1/2n where k is near n times the p that it tests
  far <- if (k / n > 0.5) 0.01 else 0.99
  tail <- (1 - level) / 2
  z <- qnorm(1 - tail)
  centre <- (k + z^2 / 2) / (n + z^2)
  reach <- z * sqrt(centre * (1 - centre) / (n + z^2))
  test <- function(correct) {
    suppressWarnings(prop.test(k, n, p = far, conf.level = level, correct = correct)$conf.int)
  }
  bounds <- rbind(
    test(FALSE),
    test(TRUE),
    binom.test(k, n, conf.level = level)$conf.int,
    c(if (k == 0) 0 else qbeta(tail, k + 0.5, n - k + 0.5),
      if (k == n) 1 else qbeta(1 - tail, k + 0.5, n - k + 0.5)),
    c(max(0, centre - reach), min(1, centre + reach)))
  data.frame(k = k, n = n, level = level,
             method = c("wilson", "wilson-cc", "clopper-pearson", "jeffreys", "agresti-coull"),
             low = bounds[, 1], high = bounds[, 2])
}

cases <- rbind(c(0, 12), c(1, 12), c(5, 12), c(11, 12), c(12, 12), c(1, 1), c(86, 120),
               c(17, 414), c(298, 414), c(414, 414), c(3, 8280))
rows <- list()
for (i in seq_len(nrow(cases))) for (level in c(0.9, 0.95, 0.99)) {
  rows[[length(rows) + 1]] <- one_case(cases[i, 1], cases[i, 2], level)
}
write_values(do.call(rbind, rows), "intervals")
