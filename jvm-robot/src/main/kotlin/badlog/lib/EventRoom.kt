package badlog.lib

/** A column into which the log itself can write what went wrong. */
internal interface EventRoom {
    /** What waits for the next row that has room. */
    val texts: EventTexts
}
