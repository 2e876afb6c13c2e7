package badlog.assistant.call

/**
 * Thrown if a tool cannot do what was requested. The message is one sentence for the assistant: the mistake, its place and the next step.
 */
internal class ToolException(override val message: String) : Exception(message)
