package badlog.rules

/**
 * Thrown if a file of rules cannot be used.
 *
 * @property lineNumber the line of the mistake, counted from 1.
 * @property message the line's number and the mistake as a sentence; below it, the line, and carets that point at the mistake.
 */
class RulesException internal constructor(val lineNumber: Int, override val message: String) : IllegalArgumentException(message)
