package badlog.cli.pack

import badlog.cli.input.Position
import java.nio.file.Path

/**
 * A slice to cut.
 *
 * @property log the log to cut it from.
 * @property at its middle.
 * @property rule the name of the rule that it is for.
 * @property condition the condition of a new rule; null for a condition that only the moment fulfills.
 * @property isSilent whether the rule must find nothing in it.
 */
internal class SliceOrder(val log: Path, val at: Position, val rule: String, val condition: String?, val isSilent: Boolean)
