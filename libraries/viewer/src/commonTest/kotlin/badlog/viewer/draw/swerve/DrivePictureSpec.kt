package badlog.viewer.draw.swerve

import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.math.PI

/** The text of a swerve drive's picture, primitive by primitive, with letters of a fixed width. */
class DrivePictureSpec : FunSpec({
    fun states(name: String, count: Int, angle: Double) = List(count) { i ->
        listOf(
            timedTopic("$name[$i]/speed", 0.0 to 2.0 + i, 10.0 to 2.0 + i),
            timedTopic("$name[$i]/angle/value", 0.0 to angle, 10.0 to angle),
        )
    }.flatten()

    fun drawn(drive: SwerveDrive, cursor: Double?, colors: PenColors = PenColors.LIGHT): List<String> {
        val picture = DrivePicture(drive, drive.errors)
        val pen = SvgPen({ text, letters, _ -> text.length * letters / 2 })
        picture.draw(pen, 300.0, Span(0.0, 10.0), Cursors(pinned = cursor), colors)
        return pen.document(300.0, picture.height.toDouble(), colors[Shade.SURFACE]).trim().removeSuffix("</svg>")
            .split("<").drop(3).map { "<$it" }.filter { it != "</text>" }
    }

    fun driveOf(vararg topics: List<Topic>) = SwerveDrive.of(timedView(*topics.toList().flatten().toTypedArray()))!!

    test("three modules without targets have a solid arrow each, two in front and one behind, with left to the left") {
        fun signAt(x: String, y: String, sign: String): List<String> {
            val text = """<text x="$x" y="$y" font-size="11" text-anchor="middle" font-weight="bold""""
            return listOf(
                """$text aria-hidden="true" fill="none" stroke="#f0f2f5" stroke-width="3" stroke-linejoin="round">$sign""",
                """$text fill="#1b2330">$sign""",
            )
        }
        drawn(driveOf(states("Measured", 3, PI / 2)), cursor = 5.0) shouldBe listOf(
            """<path d="M97.1 62.1L202.9 62.1L202.9 167.9L97.1 167.9z" fill="#f0f2f5"/>""",
            """<path d="M97.1 62.1L202.9 62.1L202.9 167.9L97.1 167.9z" stroke="#596477" fill="none" stroke-linejoin="round" stroke-width="1.5"/>""",
            """<path d="M144.5 73.1L155.5 73.1L150 64.85z" fill="#596477"/>""",
            """<text x="150" y="87.95" font-size="11" text-anchor="middle" fill="#596477">front""",
            """<path d="M97.1 60.1L77.35 60.1L77.35 57.6L68.35 62.1L77.35 66.6L77.35 64.1L97.1 64.1z" fill="#0b62c4"/>""",
            """<path d="M100.6 62.1a3.5 3.5 0 1 0 -7 0a3.5 3.5 0 1 0 7 0" fill="#0b62c4"/>""",
            *signAt("112.1", "80.95", "0").toTypedArray(),
            """<path d="M202.9 60.1L168.78 60.1L168.78 57.6L159.78 62.1L168.78 66.6L168.78 64.1L202.9 64.1z" fill="#d4501a"/>""",
            """<path d="M206.4 62.1a3.5 3.5 0 1 0 -7 0a3.5 3.5 0 1 0 7 0" fill="#d4501a"/>""",
            *signAt("187.9", "80.95", "1").toTypedArray(),
            """<path d="M150 165.9L101.5 165.9L101.5 163.4L92.5 167.9L101.5 172.4L101.5 169.9L150 169.9z" fill="#0a8062"/>""",
            """<path d="M153.5 167.9a3.5 3.5 0 1 0 -7 0a3.5 3.5 0 1 0 7 0" fill="#0a8062"/>""",
            *signAt("150", "156.75", "2").toTypedArray(),
        )
    }

    test("targets are outlines below the measured arrows, which point 10° more to the left") {
        drawn(driveOf(states("Measured", 4, PI / 18), states("Target", 4, 0.0)), cursor = 5.0).drop(4).take(2) shouldBe listOf(
            """<path d="M101.6 62.1L101.6 59.35L107.23 59.35L97.1 39.1L86.98 59.35L92.6 59.35L92.6 62.1z" """ +
                """stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="1.5"/>""",
            """<path d="M99.07 61.75L96.64 47.97L99.1 47.53L93.11 39.45L90.24 49.09L92.7 48.66L95.13 62.45z" fill="#0b62c4"/>""",
        )
    }

    test("errors are a line for each module below the robot, with the cursor") {
        val graph = drawn(driveOf(states("Measured", 4, PI / 18), states("Target", 4, 0.0)), cursor = 5.0).drop(24)
        graph.first() shouldBe """<text x="46" y="242.85" font-size="11" fill="#596477">Angle minus its target"""
        val lines = graph.filter { it.startsWith("""<path d="M46 256.67L288 256.67""") }
        lines.map { it.substringAfter("stroke=\"").substringBefore('"') } shouldBe listOf("#0b62c4", "#d4501a", "#0a8062", "#9b3fa0")
        graph.last() shouldBe """<path d="M167 250L167 352" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="2"/>"""
        graph.filter { "<text" in it }.map { it.substringAfter('>') } shouldBe listOf("Angle minus its target", "0", "5", "10 °")
    }

    test("without a cursor, there are no arrows, and the picture says where to point, in the dark theme's colors") {
        val picture = drawn(driveOf(states("Measured", 3, 0.0)), cursor = null, PenColors.DARK)
        picture.first() shouldBe """<path d="M97.1 62.1L202.9 62.1L202.9 167.9L97.1 167.9z" fill="#232b35"/>"""
        picture.size shouldBe 14
        picture.last() shouldBe """<text x="150" y="118.85" font-size="11" text-anchor="middle" fill="#9eabbb">Point at a graph."""
    }
})
