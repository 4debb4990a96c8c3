# How alike two matrices of the same labels are, natural.csv and synthetic.csv: cells (cor, RMSD of
# row proportions), and row by row (chisq.test of the two rows, Jensen-Shannon divergence in bits,
# RMSD). "ignored" says whether the column "blank" is left out before row proportions are made.
source("common/reading.R")

entropy <- function(p) -sum(p[p > 0] * log2(p[p > 0]))
divergence <- function(p, q) entropy((p + q) / 2) - (entropy(p) + entropy(q)) / 2

cells <- list()
rows <- list()
for (ignored in c("none", "blank")) {
  one <- read_matrix("natural")
  other <- read_matrix("synthetic")
  if (ignored == "blank") {
    one <- one[, colnames(one) != "blank"]
    other <- other[, colnames(other) != "blank"]
  }
  p <- row_proportions(one)
  q <- row_proportions(other)
  correct <- outer(rownames(one), colnames(one), "==")
  for (scope in c("all", "off-diagonal")) {
    used <- if (scope == "all") matrix(TRUE, nrow(p), ncol(p)) else !correct
    values <- c(cells = sum(used),
                pearson = cor(p[used], q[used]),
                spearman = cor(p[used], q[used], method = "spearman"),
                rmsd = sqrt(mean((p[used] - q[used])^2)))
    cells[[length(cells) + 1]] <- data.frame(ignored = ignored, scope = scope,
                                             quantity = names(values), value = values)
  }
  for (stimulus in rownames(one)) {
    table <- rbind(one[stimulus, ], other[stimulus, ])
    table <- table[, colSums(table) > 0]
    test <- suppressWarnings(chisq.test(table, correct = FALSE))
    rows[[length(rows) + 1]] <- data.frame(
      ignored = ignored, stimulus = stimulus, n_one = sum(one[stimulus, ]),
      n_other = sum(other[stimulus, ]), chi_square = unname(test$statistic),
      df = unname(test$parameter), p = test$p.value,
      divergence_bits = divergence(p[stimulus, ], q[stimulus, ]),
      rmsd = sqrt(mean((p[stimulus, ] - q[stimulus, ])^2)))
  }
}
write_values(do.call(rbind, cells), "likeness_cells")
write_values(do.call(rbind, rows), "likeness_rows")
