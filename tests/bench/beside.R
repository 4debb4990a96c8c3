# What bimodal_bench measures of the analysis, done in R in one thread: times in ms.

timed <- function(name, deed) {
  took <- system.time(deed())[["elapsed"]]
  cat(sprintf("R %s: %-46s %9.0f ms\n", getRversion(), name, 1e3 * took))
}

k_log_k <- function(k) sum(k[k > 0] * log2(k[k > 0]))

transmitted <- function(counts) {
  n <- sum(counts)
  log2(n) + (k_log_k(counts) - k_log_k(rowSums(counts)) - k_log_k(colSums(counts))) / n
}

# 10,000 matrices of 18 x 18 with 120 responses a row.
bootstraps_of_transmission <- function() {
  set.seed(1)
  p <- matrix(0.5 / 17, 18, 18)
  diag(p) <- 0.5
  for (draw in seq_len(10000)) transmitted(t(apply(p, 1, function(row) rmultinom(1, 120, row))))
}

# Reads 33,120 trials and counts words right by participant and condition; no phonemes, no intervals.
count_words <- function(file) {
  trials <- read.csv(file, na.strings = character())
  aggregate(stimulus == response ~ participant + condition, trials, mean)
}

set.seed(1)
words <- paste0("w", seq_len(414))
trials <- expand.grid(condition = c("A", "B", "C", "D"), stimulus = words,
                      participant = paste0("P", seq_len(20)), stringsAsFactors = FALSE)
right <- runif(nrow(trials)) < 0.5
trials$response <- ifelse(right, trials$stimulus, sample(words, nrow(trials), replace = TRUE))
file <- tempfile(fileext = ".csv")
write.csv(trials, file, row.names = FALSE)

timed("bootstraps_of_transmission", bootstraps_of_transmission)
timed("33,120 trials read, words counted only", function() count_words(file))
