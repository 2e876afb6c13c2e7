package badlog.charts.match

import badlog.rules.number.LogNumbers
import badlog.signals.match.MatchOfLog

/**
 * What charts show of a log.
 *
 * @property match the match that it is of, as far as that is known.
 * @property file the name of its file, which stands for a match that is not known.
 * @property began when it began, in s since 1970 on a clock on the wall; null if only the time of its file is known, which copying changes.
 * @property numbers the numbers that summarize it.
 */
class ChartedLog(val match: MatchOfLog, val file: String, val began: Long?, val numbers: LogNumbers)
