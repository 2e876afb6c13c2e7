package badlog.window.log

import badlog.files.LogFile
import badlog.signals.clock.FoundStation
import java.nio.file.Path

/**
 * A person's choices for one log: formulas, x axis, Driver Station log, and field.
 *
 * @property definitions the definitions of the formulas calculated in it.
 * @property overTime whether it is drawn over its time if it names no x axis.
 * @property station the Driver Station's log of the same match that is shown with it; null for none.
 * @property field the file of the field on which its paths are drawn; null for the field beside the log.
 * @property fieldSelections the number of a person's selections of a field: the same file may have changed in between.
 */
internal data class RecordingChoices(
    val definitions: List<String> = emptyList(),
    val overTime: Boolean = false,
    val station: FoundStation<LogFile>? = null,
    val field: Path? = null,
    val fieldSelections: Int = 0,
)
