# What all scripts share: the folder to write into is their argument; matrices are in inputs/.

folder <- commandArgs(trailingOnly = TRUE)[1]

# Counts with stimuli as names of rows, responses as names of columns.
read_matrix <- function(name) {
  table <- read.csv(file.path("inputs", paste0(name, ".csv")), check.names = FALSE,
                    na.strings = character(), row.names = 1)
  as.matrix(table)
}

# 15 significant digits.
write_values <- function(values, name) {
  write.csv(values, file.path(folder, paste0(name, ".csv")), row.names = FALSE, quote = FALSE)
}

row_proportions <- function(counts) counts / rowSums(counts)

# Square root of phi-square of two rows, by R's chi-square test (without Yates).
phi <- function(one, other) {
  table <- rbind(one, other)
  table <- table[, colSums(table) > 0]
  if (ncol(table) < 2) return(0)
  test <- suppressWarnings(chisq.test(table, correct = FALSE))
  sqrt(unname(test$statistic) / sum(table))
}

phi_matrix <- function(counts) {
  n <- nrow(counts)
  values <- matrix(0, n, n, dimnames = list(rownames(counts), rownames(counts)))
  for (i in seq_len(n)) for (j in seq_len(n)) values[i, j] <- phi(counts[i, ], counts[j, ])
  values
}
