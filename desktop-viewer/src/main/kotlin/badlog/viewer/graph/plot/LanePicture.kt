package badlog.viewer.graph.plot

import badlog.plot.lane.LaneBlocks

/**
 * A lane of states in pixels.
 *
 * @property states what each number means.
 * @property blocks what is drawn, from left to right, the short ones last.
 */
internal class LanePicture(val line: DrawnLine, val states: List<String>, val blocks: LaneBlocks)
