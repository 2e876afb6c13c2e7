package badlog.cli.analysis

/** Nothing can be looked for as it was asked. The message is for a person. */
internal class SearchException(override val message: String) : Exception(message)
