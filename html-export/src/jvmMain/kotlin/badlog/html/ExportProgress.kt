package badlog.html

/**
 * Hears how far an export is. Called on the exporting thread, about once a megabyte. What it throws stops the export,
 * which then leaves nothing behind and passes the exception on.
 */
fun interface ExportProgress {
    /** [done] of the input's [total] bytes are in the page; [total] is off when the input is still being written. */
    fun advanced(done: Long, total: Long)
}
