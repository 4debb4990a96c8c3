# Compares tables of values, made just now, with those that are stored: Rscript compare.R MADE STORED.
# Texts are the same; numbers differ by at most 1e-9 plus 1e-9 of the stored one (versions of R and
# of its libraries round differently in the last digits). Prints what differs; ends with 1 if
# anything does.

tolerance <- 1e-9

folders <- commandArgs(trailingOnly = TRUE)
read_values <- function(folder, file) {
  read.csv(file.path(folder, file), check.names = FALSE, na.strings = character())
}

# Which of the made values differ from the stored ones.
differ <- function(made, stored) {
  if (!is.numeric(made) || !is.numeric(stored)) return(as.character(made) != as.character(stored))
  !(abs(made - stored) <= tolerance + tolerance * abs(stored))
}

judge <- function(file) {
  if (!file.exists(file.path(folders[1], file))) return(paste0(file, ": no script makes it"))
  if (!file.exists(file.path(folders[2], file))) return(paste0(file, ": not stored yet"))
  made <- read_values(folders[1], file)
  stored <- read_values(folders[2], file)
  if (!identical(names(made), names(stored)) || nrow(made) != nrow(stored)) {
    return(paste0(file, ": other columns or another number of lines than stored"))
  }
  unlist(lapply(names(made), function(column) {
    lines <- which(differ(made[[column]], stored[[column]]))
    sprintf("%s:%d: %s is %s now, %s stored", file, lines + 1, column,
            format(made[[column]][lines], digits = 15), format(stored[[column]][lines], digits = 15))
  }))
}

files <- sort(unique(unlist(lapply(folders, list.files, pattern = "[.]csv$"))))
findings <- unlist(lapply(files, judge))
if (length(findings) > 0) {
  writeLines(findings)
  quit(status = 1)
}
cat(sprintf("%d files of values are as stored (%s)\n", length(files), R.version.string))
