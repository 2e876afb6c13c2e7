package badlog.lib

/**
 * What a log has been through since [BadLog.init], at one moment.
 *
 * @property rowsWritten rows that were handed to the operating system, and not into a file known to be deleted.
 * @property rowsMissed rows that were lost because they could not be written, or because the file is known to be
 *   deleted, which is noticed half a second later at most.
 * @property bytesWritten how long the file is, in bytes.
 * @property slowestRowNanos the longest that one call of [BadLog.log] took, in nanoseconds.
 * @property slowWrites writes that took more than 5 ms, also those that failed.
 * @property failedSyncs times that the operating system could not bring the file to the disk.
 * @property cellsMissed cells left empty because a supplier threw or gave null.
 * @property callsIgnored calls that could not be followed, such as publishing to a name that was never created.
 * @property eventsDropped events that no row took: they came faster than rows, or the log ended before one could be
 *   written.
 */
public class LogCounters internal constructor(
    public val rowsWritten: Long,
    public val rowsMissed: Long,
    public val bytesWritten: Long,
    public val slowestRowNanos: Long,
    public val slowWrites: Long,
    public val failedSyncs: Long,
    public val cellsMissed: Long,
    public val callsIgnored: Long,
    public val eventsDropped: Long,
) {
    override fun toString(): String =
        "$rowsWritten rows written, $rowsMissed missed; $bytesWritten bytes; slowest row $slowestRowNanos ns; " +
            "$slowWrites slow writes, $failedSyncs failed syncs; $cellsMissed cells missed; " +
            "$callsIgnored calls ignored; $eventsDropped events dropped"
}
