package badlog.window.log

import java.nio.file.Path

/**
 * Reads recordings as the window shows them, off its thread.
 *
 * @param library gives the folder of logs.
 * @param choices gives what a person has chosen of what is shown of a recording.
 */
internal class RecordingReader(private val library: () -> Path?, private val choices: (OpenRecording) -> RecordingChoices) {
    /**
     * Reads [file], see [OpenRecording.read].
     *
     * @param definitions returns the formulas to calculate in it; null for those chosen.
     */
    fun read(
        file: Path,
        isGrowing: Boolean = false,
        definitions: ((OpenRecording) -> List<String>)? = null,
        progress: (Float) -> Unit = {},
    ): OpenRecording = OpenRecording.read(
        file,
        library(),
        isGrowing,
        { opened -> choices(opened).let { if (definitions == null) it else it.copy(definitions = definitions(opened)) } },
        progress,
    )
}
