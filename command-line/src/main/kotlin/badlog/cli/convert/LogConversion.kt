package badlog.cli.convert

import badlog.cli.output.OutputFormat

/**
 * The options for converting logs.
 *
 * @property isGzip whether to compress results although their logs were not.
 * @property xTopic the topic to make the x axis; null for the log's own.
 * @property rows the times of rows for a log without rows, if the format needs them.
 * @property isChangesOnly whether to skip samples that equal the previous ones.
 */
internal class LogConversion(val format: OutputFormat, val isGzip: Boolean, val xTopic: String?, val rows: Rows, val isChangesOnly: Boolean)
