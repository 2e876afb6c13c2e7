package badlog.cli.input

/** The bytes of a file are no log at all. The message is one sentence for a person. */
internal class NotALog(override val message: String) : Exception(message)
