package badlog.assistant.call

/** A tool cannot do what it was asked for. The message is one sentence for the assistant: what, where, and what to do. */
internal class ToolException(override val message: String) : Exception(message)
