package badlog.cli.convert

import badlog.cli.output.LogFormat

/**
 * How logs are converted.
 *
 * @property isGzip whether to compress results although their logs were not.
 * @property xTopic the topic to make the x axis, or null.
 * @property rows the times of rows for a log without rows, if the format needs them.
 * @property isChangesOnly whether to skip samples that equal the previous ones.
 */
internal class LogConversion(val format: LogFormat, val isGzip: Boolean, val xTopic: String?, val rows: Rows, val isChangesOnly: Boolean)
