# A hook for badlog: how much each topic varies. Needs R and the package jsonlite.
#
# Try it by hand:  Rscript analyze.R header.json < log.csv
library(jsonlite)

arguments <- commandArgs(trailingOnly = TRUE)
path <- if (length(arguments) > 0) arguments[1] else Sys.getenv("BADLOG_HEADER")
header <- fromJSON(path, simplifyVector = FALSE)
is_x <- function(topic) "xaxis" %in% unlist(topic$attrs)
x_names <- vapply(Filter(is_x, header$topics), function(topic) topic$name, "")

log <- read.csv(file("stdin", encoding = "UTF-8"), check.names = FALSE, na.strings = c("", "NaN", "null"))
numeric <- names(log)[vapply(log, is.numeric, TRUE)]
deviations <- vapply(setdiff(numeric, x_names), function(name) sd(log[[name]], na.rm = TRUE), 0)
deviations <- deviations[is.finite(deviations)]
most <- head(sort(deviations, decreasing = TRUE), 5)

figure <- tempfile(fileext = ".png")
png(figure, width = 800, height = 400)
barplot(most, names.arg = basename(names(most)), ylab = "standard deviation")
invisible(dev.off())

values <- setNames(as.list(sprintf("%.4g", most)), paste("Deviation of", names(most)))
figures <- list(list(title = "What varies most", png = base64_enc(readBin(figure, "raw", file.size(figure)))))
cat(toJSON(list(values = values, figures = figures), auto_unbox = TRUE))
