# d' of yes and no with the log-linear correction (Hautus, 1995): hits and false alarms + 1/2, trials
# + 1; and of one out of m alternatives, from P = integral of phi(x - d') Phi(x)^(m-1) dx by
# integrate and uniroot.
source("common/reading.R")

yes_no <- rbind(c(18, 20, 4, 20), c(20, 20, 0, 20), c(0, 12, 0, 15), c(5, 40, 11, 38),
                c(300, 414, 57, 414))
hit <- (yes_no[, 1] + 0.5) / (yes_no[, 2] + 1)
alarm <- (yes_no[, 3] + 0.5) / (yes_no[, 4] + 1)
write_values(data.frame(hits = yes_no[, 1], signals = yes_no[, 2], false_alarms = yes_no[, 3],
                        noises = yes_no[, 4], d_prime = qnorm(hit) - qnorm(alarm),
                        criterion = -(qnorm(hit) + qnorm(alarm)) / 2),
             "yes_no")

correct_of <- function(d, m) {
  part <- function(x) dnorm(x - d) * pnorm(x)^(m - 1)
  integrate(part, -Inf, d, rel.tol = 1e-12)$value + integrate(part, d, Inf, rel.tol = 1e-12)$value
}
alternatives <- list()
for (m in c(2, 3, 4, 8, 18)) for (p in c(0.05, 0.3, 0.5, 0.75, 0.9, 0.99)) {
  if (p < 0.6 / m) next  # far below chance
  root <- uniroot(function(d) correct_of(d, m) - p, c(-3, 8), tol = 1e-13)$root
  # 0 at chance, where no digit is right
  alternatives[[length(alternatives) + 1]] <- data.frame(
    alternatives = m, proportion = p, d_prime = if (abs(root) < 1e-9) 0 else root)
}
write_values(do.call(rbind, alternatives), "alternatives")
