package badlog.analysis

/**
 * A text with a time.
 *
 * @property x where it stands on the x axis; NaN where the x axis has a gap.
 * @property row the row it was logged in, from 0; of a topic with times of its own, the sample.
 */
public class Event(public val x: Double, public val row: Int, public val text: String)
