package badlog.cli

/** Why something cannot be done with a log. The message is one sentence for a person: what, where, and what to do. */
internal class Failure(override val message: String) : Exception(message)
