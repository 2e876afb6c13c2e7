package badlog.viewer.graph.plot

import badlog.analysis.Series
import badlog.plot.lane.LaneBlock

/**
 * A lane of states in pixels.
 *
 * @property series its samples, for the state under the cursor.
 * @property states what each number means.
 * @property blocks what is drawn, from left to right, the short ones last.
 */
internal class LanePicture(val line: DrawnLine, val series: Series, val states: List<String>, val blocks: List<LaneBlock>)
