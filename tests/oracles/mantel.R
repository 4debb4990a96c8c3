# Mantel's test of two 5 x 5 matrices (five_one.csv, five_other.csv) by all 120 orders of the labels
# of the other: Pearson's r of the lower triangles of their phi dissimilarities, and of their
# symmetrised row proportions (p_ij + p_ji) / 2; p is the part of all orders, the given one among
# them, whose r is at least as large (rounding apart). Also the mean and the largest r of all.
source("common/reading.R")

orders <- function(items) {
  if (length(items) == 1) return(list(items))
  found <- list()
  for (i in seq_along(items)) {
    found <- c(found, lapply(orders(items[-i]), function(rest) c(items[i], rest)))
  }
  found
}

symmetrised <- function(counts) {
  p <- row_proportions(counts)
  (p + t(p)) / 2
}

lower <- function(values) values[lower.tri(values)]

rows <- list()
for (measure in c("phi", "symmetrised")) {
  make <- if (measure == "phi") phi_matrix else symmetrised
  one <- make(read_matrix("five_one"))
  other <- make(read_matrix("five_other"))
  all <- sapply(orders(seq_len(nrow(one))),
                function(order) cor(lower(one), lower(other[order, order])))
  observed <- cor(lower(one), lower(other))
  values <- c(r = observed, orders = length(all), at_least = sum(all >= observed - 1e-12),
              p = mean(all >= observed - 1e-12), mean_r = mean(all), largest_r = max(all))
  rows[[length(rows) + 1]] <- data.frame(measure = measure, quantity = names(values),
                                         value = ifelse(abs(values) < 1e-12, 0, values))
}
write_values(do.call(rbind, rows), "mantel")
