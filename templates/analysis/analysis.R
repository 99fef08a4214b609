# Means, choices and tests: repeats the results page from the raw answers.
#
# Put this script beside the long table (CSV) and run it there, or run it in the folder analysis/
# of the dataset. It needs nothing but R. The page's permutation test draws at random and is not
# repeated here.

# The study
against <- "others"  # the other clips of the best one's body; "all" keeps the best among them

# The answers that count: complete participants only, none that was excluded, of each clip the
# newest answer, no practice and no attention checks.
files <- if (file.exists(answers_file)) answers_file else
  list.files("../data", pattern = "_data\\.csv$", full.names = TRUE)
files <- grep("_description-moves_", files, value = TRUE, invert = TRUE) # paths of sliders
answers <- do.call(rbind, lapply(files, read.csv, check.names = FALSE, encoding = "UTF-8"))
counted <- answers[
  answers$session_state == "complete" & answers$excluded == 0 & answers$newest == 1 &
  answers$practice == 0 & (is.na(answers$check) | answers$check == ""), ]
cat(nrow(answers), "rows,", length(unique(counted$session)), "complete participants\n")
of_part <- function(part)
  counted[counted$part == part & counted$version %in% versions[[part]], ]
enough <- function(part) length(unique(of_part(part)$session)) >= needed

# Every clip on every scale: means with 95 % intervals; between opposite words, toward the right
# pole is positive.
mean_interval <- function(values) {
  values <- values[!is.na(values)]
  n <- length(values)
  if (n < needed) return(c(n = n, mean = NA, sd = NA, low = NA, high = NA))
  reach <- qt(0.975, n - 1) * sd(values) / sqrt(n)
  c(n = n, mean = mean(values), sd = sd(values),
    low = mean(values) - reach, high = mean(values) + reach)
}
by_person <- function(column) {  # one row a participant, one column a clip
  part <- numbers[[column]][1]
  rows <- of_part(part)
  people <- factor(rows$session, unique(rows$session))
  tapply(rows[[column]], list(people, factor(rows$stimulus_hash, clips[[part]]$hash)), mean,
         na.rm = TRUE)  # several ratings of a clip are averaged
}
means <- do.call(rbind, lapply(names(numbers), function(column) {
  found <- apply(by_person(column), 2, mean_interval)
  data.frame(scale = column, clip = clips[[numbers[[column]][1]]]$label, t(found),
             row.names = NULL)
}))
print(means)

# What was chosen, of the trials that showed it, with Wilson's 95 % intervals. Answers of one
# participant are not independent.
shared <- function(column, name, chosen, shown) {
  z <- qnorm(0.975)
  share <- if (shown > 0) chosen / shown else NA
  middle <- (share + z^2 / (2 * shown)) / (1 + z^2 / shown)
  reach <- z / (1 + z^2 / shown) * sqrt(share * (1 - share) / shown + (z / (2 * shown))^2)
  data.frame(column = column, name = name, chosen = chosen, shown = shown,
             share = share, low = middle - reach, high = middle + reach)
}
chosen <- lapply(names(choices), function(column) {
  part <- choices[[column]][1]
  if (!enough(part)) return(NULL)
  rows <- of_part(part)
  taken <- rows[[paste0(column, "__hash")]]
  taken[is.na(taken)] <- ""
  shown <- unlist(strsplit(rows$stimuli_hashes, "|", fixed = TRUE))
  found <- do.call(rbind, lapply(seq_len(nrow(clips[[part]])), function(i) {
    clip <- clips[[part]]$hash[i]
    shared(column, clips[[part]]$label[i], sum(taken == clip), sum(shown == clip))
  }))
  if (choices[[column]][2] != "")
    found <- rbind(found, shared(column, choices[[column]][2], sum(taken == ""), length(taken)))
  found
})
recognised <- lapply(names(correct), function(column) {
  part <- correct[[column]]
  if (!enough(part)) return(NULL)
  rows <- of_part(part)
  pairs <- t(sapply(strsplit(rows$stimuli_hashes, "|", fixed = TRUE), function(one)
    sort(match(one[1:2], clips[[part]]$hash))))
  each <- unique(pairs[order(pairs[, 1], pairs[, 2]), , drop = FALSE])
  found <- do.call(rbind, lapply(seq_len(nrow(each)), function(i) {
    own <- pairs[, 1] == each[i, 1] & pairs[, 2] == each[i, 2]
    shared(column, paste(clips[[part]]$label[each[i, ]], collapse = " and "),
           sum(rows[[column]][own]), sum(own))
  }))
  if (nrow(each) > 1)
    found <- rbind(shared(column, "all pairs", sum(rows[[column]]), nrow(rows)), found)
  found
})
shares <- do.call(rbind, c(chosen, recognised))
if (!is.null(shares)) print(shares)

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
seen <- function(column, pole, sign) {
  part <- numbers[[column]][1]
  own <- clips[[part]]
  toward <- sign * by_person(column)
  best <- which.max(colMeans(toward, na.rm = TRUE))
  rest <- own$body == own$body[best]
  if (against == "others") rest[best] <- FALSE
  x <- toward[!is.na(toward[, best]), best]
  y <- toward[, rest][!is.na(toward[, rest])]
  row <- data.frame(
    part = part, scale = column, pole = pole, clip = NA_character_,
    mean = NA_real_, others = NA_real_, difference = NA_real_,
    t = NA_real_, df = NA_real_, p = NA_real_, p_holm = NA_real_,
    d = NA_real_, d_low = NA_real_, d_high = NA_real_,
    paired_t = NA_real_, paired_df = NA_real_, paired_p = NA_real_)
  if (!any(rest)) return(row)  # the body has no other clip
  row$clip <- own$label[best]
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
poles <- do.call(rbind, lapply(bipolar, function(column) {
  if (!enough(numbers[[column]][1])) return(NULL)
  rbind(seen(column, numbers[[column]][2], -1), seen(column, numbers[[column]][3], 1))
}))
if (!is.null(poles)) {
  for (part in unique(poles$part))
    poles$p_holm[poles$part == part] <- p.adjust(poles$p[poles$part == part], "holm")
  print(poles)
}
