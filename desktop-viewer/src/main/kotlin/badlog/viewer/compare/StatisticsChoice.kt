package badlog.viewer.compare

/** What the table of statistics shows; completed below. */
internal class StatisticsChoice
