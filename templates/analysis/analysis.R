# Means and tests: repeats the results page from the raw answers.
#
# Put this script beside the long table (CSV) and run it there, or run it in the folder analysis/
# of the dataset. It needs nothing but R. The page's permutation test draws at random and is not
# repeated here.

# The study
against <- "others"  # the other clips of the best one's body; "all" keeps the best among them

# The answers that count: complete participants only, of each clip the newest answer, no practice.
files <- if (file.exists(answers_file)) answers_file else
  list.files("../data", pattern = "_data\\.csv$", full.names = TRUE)
answers <- do.call(rbind, lapply(files, read.csv, check.names = FALSE, encoding = "UTF-8"))
counted <- answers[
  answers$session_state == "complete" & answers$newest == 1 & answers$practice == 0, ]
people <- unique(counted$session)
cat(nrow(answers), "answers,", length(people), "complete participants\n")

# Every clip on every scale: means with 95 % intervals; toward the right pole is positive.
mean_interval <- function(values) {
  values <- values[!is.na(values)]
  n <- length(values)
  if (n < needed) return(c(n = n, mean = NA, sd = NA, low = NA, high = NA))
  reach <- qt(0.975, n - 1) * sd(values) / sqrt(n)
  c(n = n, mean = mean(values), sd = sd(values),
    low = mean(values) - reach, high = mean(values) + reach)
}
means <- do.call(rbind, lapply(names(scales), function(scale) {
  found <- sapply(clips$hash, function(clip)
    mean_interval(counted[counted$stimulus_hash == clip, scale]))
  data.frame(scale = scale, clip = clips$label, t(found), row.names = NULL)
}))
print(means)

# Is every pole seen? The clip with the highest mean toward it against the clips of the same body.
# The best clip was chosen by its mean, so these tests find differences a little too easily; the
# page's permutation test allows for the choice.
cohens_d <- function(x, y) {
  df <- length(x) + length(y) - 2
  pooled <- sqrt(((length(x) - 1) * var(x) + (length(y) - 1) * var(y)) / df)
  scale <- sqrt(length(x) * length(y) / (length(x) + length(y)))
  t <- (mean(x) - mean(y)) / pooled * scale
  reach <- 5 * sqrt(1 + t^2 / (2 * df))
  limit <- function(probability) uniroot(
    function(noncentrality) pt(t, df, noncentrality) - probability,
    c(t - reach, t + reach), tol = 1e-10)$root / scale
  c(t / scale, limit(0.975), limit(0.025))
}
seen <- function(scale, pole, sign) {
  toward <- matrix(NA_real_, length(people), nrow(clips), dimnames = list(people, clips$hash))
  toward[cbind(counted$session, counted$stimulus_hash)] <- sign * counted[[scale]]
  best <- which.max(colMeans(toward, na.rm = TRUE))
  rest <- clips$body == clips$body[best]
  if (against == "others") rest[best] <- FALSE
  x <- toward[!is.na(toward[, best]), best]
  y <- toward[, rest][!is.na(toward[, rest])]
  row <- data.frame(
    scale = scale, pole = pole, clip = NA_character_,
    mean = NA_real_, others = NA_real_, difference = NA_real_,
    t = NA_real_, df = NA_real_, p = NA_real_, p_holm = NA_real_,
    d = NA_real_, d_low = NA_real_, d_high = NA_real_,
    paired_t = NA_real_, paired_df = NA_real_, paired_p = NA_real_)
  if (!any(rest)) return(row)  # the body has no other clip
  row$clip <- clips$label[best]
  row[c("mean", "others", "difference")] <- c(mean(x), mean(y), mean(x) - mean(y))
  if (min(length(x), length(y)) > 1 && sd(x) + sd(y) > 0) {
    welch <- t.test(x, y)
    row[c("t", "df", "p")] <- c(welch$statistic, welch$parameter, welch$p.value)
    row[c("d", "d_low", "d_high")] <- cohens_d(x, y)
  }
  differences <- toward[, best] - rowMeans(toward[, rest, drop = FALSE], na.rm = TRUE)
  differences <- differences[!is.na(differences)]
  if (length(differences) > 1 && diff(range(differences)) > 1e-12) {
    paired <- t.test(differences)
    row[c("paired_t", "paired_df", "paired_p")] <-
      c(paired$statistic, paired$parameter, paired$p.value)
  }
  row
}
if (length(people) < needed) stop("These tests need ", needed, " complete participants.")
poles <- do.call(rbind, lapply(names(scales), function(scale) rbind(
  seen(scale, scales[[scale]][1], -1), seen(scale, scales[[scale]][2], 1))))
poles$p_holm <- p.adjust(poles$p, "holm")
print(poles)
