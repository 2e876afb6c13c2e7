package badlog.lib

/** A column into which the log itself can write what went wrong. */
internal fun interface EventRoom {
    /** Keeps [text] for the next row that has room. May be called by any thread. */
    fun note(text: String)
}
