# Entropies and what was transmitted, in bits, from the definitions (Miller & Nicely, 1955), its two
# corrections (Miller-Madow; Miller, 1955), and what was transmitted of features, responses that
# have no value of the feature left out.
source("common/reading.R")

entropy <- function(counts) {
  p <- counts[counts > 0] / sum(counts)
  -sum(p * log2(p))
}

quantities <- function(counts) {
  n <- sum(counts)
  x <- rowSums(counts)
  y <- colSums(counts)
  transmitted <- entropy(x) + entropy(y) - entropy(counts)
  unit <- 1 / (2 * n * log(2))
  occurring <- function(values) sum(values > 0)
  c(n = n,
    stimulus_entropy = entropy(x),
    response_entropy = entropy(y),
    joint_entropy = entropy(counts),
    transmitted = transmitted,
    relative = transmitted / entropy(x),
    miller_madow = transmitted + (occurring(x) + occurring(y) - occurring(counts) - 1) * unit,
    all_cells_possible = transmitted - (occurring(x) - 1) * (occurring(y) - 1) * unit)
}

features <- read.csv("inputs/features.csv", row.names = 1)
rows <- list()
for (name in c("small", "natural", "synthetic")) {
  counts <- read_matrix(name)
  whole <- quantities(counts)
  rows[[length(rows) + 1]] <- data.frame(matrix = name, feature = "(all)",
                                         quantity = names(whole), value = whole)
  for (feature in names(features)) {
    kept <- counts[, colnames(counts) %in% rownames(features)]
    groups <- rowsum(t(rowsum(kept, features[rownames(kept), feature])),
                     features[colnames(kept), feature])
    part <- quantities(t(groups))
    rows[[length(rows) + 1]] <- data.frame(matrix = name, feature = feature,
                                           quantity = names(part), value = part)
  }
}
values <- do.call(rbind, rows)
# where all stimuli have the same value of a feature, T / H(x) is none
write_values(values[!is.nan(values$value), ], "information")
