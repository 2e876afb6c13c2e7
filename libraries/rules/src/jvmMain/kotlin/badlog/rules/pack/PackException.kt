package badlog.rules.pack

/**
 * Thrown if a pack cannot be used.
 *
 * @property message the problem, its place and the remedy, as a sentence; for a mistake in one of its files, with the line below it.
 */
class PackException internal constructor(override val message: String) : Exception(message)
