package badlog.assistant.call

/** Thrown if a tool cannot do what was requested. The message is one sentence for the assistant: what, where, and what to do. */
internal class ToolException(override val message: String) : Exception(message)
