package badlog.cli

import kotlinx.serialization.json.JsonElement

/**
 * What came of one log.
 *
 * @property isSalvaged whether something of the log is lost.
 * @property text what a person reads about it.
 * @property json what a program reads about it, in this order, besides its file and status.
 */
internal class Outcome(val isSalvaged: Boolean, val text: String, val json: Map<String, JsonElement>)
