# Correlations of short series, with ties and without (cor), and p values adjusted for the false
# discovery rate (p.adjust, Benjamini & Hochberg, 1995).
source("common/reading.R")

series <- list(
  plain = list(x = c(1, 4, 2, 8, 5.5), y = c(2, 3, 1, 9, 10)),
  ties = list(x = c(0, 0, 0, 3, 1, 1, 7), y = c(0, 2, 0, 2, 2, 1, 5)),
  falling = list(x = c(1, 2, 3, 4), y = c(8, 4, 2, 1)))
rows <- list()
for (name in names(series)) {
  x <- series[[name]]$x
  y <- series[[name]]$y
  rows[[length(rows) + 1]] <- data.frame(
    series = name, x = paste(x, collapse = " "), y = paste(y, collapse = " "),
    pearson = cor(x, y), spearman = cor(x, y, method = "spearman"))
}
write_values(do.call(rbind, rows), "correlations")

families <- list(
  textbook = c(0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344, 0.0459, 0.3240,
               0.4262, 0.5719, 0.6528, 0.7590, 1.0000),
  unordered = c(0.04, 0.001, 0.9, 0.03, 0.03, 0.2),
  one = 0.07)
adjusted <- lapply(names(families), function(name) {
  p <- families[[name]]
  data.frame(family = name, index = seq_along(p) - 1, p = p, adjusted = p.adjust(p, "BH"))
})
write_values(do.call(rbind, adjusted), "false_discovery")
