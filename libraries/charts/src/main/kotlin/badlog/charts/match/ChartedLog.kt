package badlog.charts.match

import badlog.rules.number.LogNumbers
import badlog.signals.match.MatchOfLog

/**
 * The data of a log for charts.
 *
 * @property match its match; parts may be unknown.
 * @property file the name of its file, used in place of an unknown match.
 * @property began the local time at which it began, in s since 1970; null if only the time of its file is known, which copying changes.
 * @property numbers the numbers that summarize it.
 */
class ChartedLog(val match: MatchOfLog, val file: String, val began: Long?, val numbers: LogNumbers)
