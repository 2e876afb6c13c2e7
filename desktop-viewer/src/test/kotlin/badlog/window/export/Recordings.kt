package badlog.window.export

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.window.log.OpenRecording
import java.nio.file.Path

/** Returns the recording of [text], the content of a bag or of a CSV file. */
internal fun recordingOf(text: String, file: Path = Path.of("match.bag").toAbsolutePath()): OpenRecording {
    val parser = BagParser()
    parser.accept(text.encodeToByteArray())
    return OpenRecording(file, LogView.of(parser.finish()))
}

/**
 * Returns a bag of [rows] rows, 0.02 s apart, with a value. Its topics: `Arm/Angle` in degrees, `Arm/Current` in amperes, `Arm/Mode` in
 * texts.
 */
internal fun armBag(rows: Int, angle: (Int) -> String = { (it % 50).toString() }): String = buildString {
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Arm/Angle","unit":"deg","attrs":["zero"]},""")
    append("""{"name":"Arm/Current","unit":"A","attrs":[]},{"name":"Arm/Mode","unit":"ul","attrs":[]}],""")
    append(""""values":[{"name":"Match Number","value":"8"}]}""").append('\n')
    append("Time,Arm/Angle,Arm/Current,Arm/Mode\n")
    for (row in 0 until rows) {
        append(row / 50.0).append(',').append(angle(row)).append(',').append(row * 0.5).append(',')
        append(if (row / 40 % 2 == 0) "hold" else "move").append('\n')
    }
}
