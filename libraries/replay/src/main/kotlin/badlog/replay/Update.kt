package badlog.replay

/**
 * A value that is to be sent: sample [index] of the signal numbered [signal].
 *
 * @property micros when it began to hold, in the server's time.
 */
internal class Update(val signal: Int, val index: Int, val micros: Long)
