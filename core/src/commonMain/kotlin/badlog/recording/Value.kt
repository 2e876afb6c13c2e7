package badlog.recording

/**
 * A name and a text that were known when the recording began, such as the match number.
 *
 * @property name the full name; `/` makes folders, see [PathName].
 * @property text the value; may be empty.
 */
public data class Value(public val name: String, public val text: String)
