# The square root of phi-square of every two rows (chisq.test), and the same rows clustered (hclust)
# and laid out (cmdscale).
source("common/reading.R")

pairs <- list()
merges <- list()
layouts <- list()
for (name in c("small", "natural", "synthetic")) {
  unlike <- phi_matrix(read_matrix(name))
  for (i in seq_len(nrow(unlike))) for (j in seq_len(i - 1)) {
    pairs[[length(pairs) + 1]] <- data.frame(matrix = name, one = rownames(unlike)[j],
                                             other = rownames(unlike)[i], phi = unlike[i, j])
  }
  n <- nrow(unlike)
  for (linkage in c("single", "complete", "average")) {
    tree <- hclust(as.dist(unlike), method = linkage)
    # clusters 0 to n-1 are the rows, merge k (from 0) makes the cluster n+k
    number <- ifelse(tree$merge < 0, -tree$merge - 1, tree$merge + n - 1)
    merges[[length(merges) + 1]] <- data.frame(
      matrix = name, linkage = linkage, merge = seq_len(n - 1) - 1,
      one = pmin(number[, 1], number[, 2]), other = pmax(number[, 1], number[, 2]),
      height = tree$height)
  }
  layout <- cmdscale(as.dist(unlike), k = 2, eig = TRUE)
  distances <- dist(layout$points)
  stress <- sqrt(sum((distances - as.dist(unlike))^2) / sum(distances^2))
  values <- c(layout$eig, as.vector(distances), stress)
  layouts[[length(layouts) + 1]] <- data.frame(
    matrix = name,
    quantity = c(rep("eigenvalue", n), rep("distance", length(distances)), "stress_1"),
    index = c(seq_len(n), seq_along(distances), 1) - 1,
    # of eigenvalues that are 0 no digit is right
    value = ifelse(abs(values) < 1e-12, 0, values))
}
write_values(do.call(rbind, pairs), "phi")
write_values(do.call(rbind, merges), "clusters")
write_values(do.call(rbind, layouts), "layout")
