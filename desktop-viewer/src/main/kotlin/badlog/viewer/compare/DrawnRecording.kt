package badlog.viewer.compare

import badlog.viewer.recording.OpenRecording

/**
 * A recording that graphs draw.
 *
 * @property offset what is added to its x to stand where the open recording has the same moment; 0 for that one itself.
 * @property name what it is called beside the others that are drawn.
 */
internal data class DrawnRecording(val recording: OpenRecording, val offset: Double = 0.0, val name: String = recording.label)
