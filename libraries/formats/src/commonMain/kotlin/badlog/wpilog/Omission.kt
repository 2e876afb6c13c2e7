package badlog.wpilog

/**
 * Something of a recording that a file of another format cannot carry.
 *
 * @property topic the topic it belongs to, or null where it belongs to none or to many.
 * @property what one sentence that says what is missing, or what stands in its place.
 * @property count how many samples, topics or texts it concerns.
 */
public data class Omission(public val topic: String?, public val what: String, public val count: Int = 1)
