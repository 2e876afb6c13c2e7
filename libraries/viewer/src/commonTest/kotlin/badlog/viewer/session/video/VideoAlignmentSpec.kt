package badlog.viewer.session.video

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class VideoAlignmentSpec : FunSpec({
    val seconds = Arb.numericDouble(0.0, 10_000.0)
    val unit = Arb.element(1.0, 0.001, 1e-6, 60.0)

    test("an aligned frame has its x, and all others their distance in the video, in any unit of x") {
        checkAll(seconds, Arb.numericDouble(-5000.0, 5000.0), unit, seconds) { frame, moment, secondsOfX, other ->
            val x = moment / secondsOfX
            val alignment = VideoAlignment.of(frame, x, secondsOfX)
            alignment.secondsAt(x, secondsOfX) shouldBe (frame plusOrMinus 1e-4)
            alignment.xAt(other, secondsOfX) * secondsOfX shouldBe (moment + other - frame plusOrMinus 1e-4)
            alignment.secondsAt(alignment.xAt(other, secondsOfX), secondsOfX) shouldBe (other plusOrMinus 1e-6)
        }
    }

    test("a stored alignment is read back the same, to the last bit") {
        checkAll(Arb.string(0..20), Arb.numericDouble(-1e6, 1e6).orNull()) { name, start ->
            val read = videoNoteOf(VideoNote(name, start?.let(::VideoAlignment)).toText())
            read?.name shouldBe name
            read?.alignment?.startSeconds shouldBe start?.let { VideoAlignment(it).startSeconds }
        }
        VideoNote("a match.mp4", VideoAlignment(-1.94667000001)).toText() shouldBe "-1.9467 a match.mp4"
    }

    test("each video of a log has its own note, and a later note about the same video replaces the earlier one") {
        val first = VideoNote("match.mp4", VideoAlignment(12.5)).within("")
        val both = VideoNote("pit.mp4", null).within(first)
        both.lines() shouldBe listOf("12.5 match.mp4", "- pit.mp4")
        VideoNote("match.mp4", VideoAlignment(7.5)).within(both).lines() shouldBe listOf("- pit.mp4", "7.5 match.mp4")
    }

    test("other text is not read as an alignment") {
        for (text in listOf("", "12.5", "x match.mp4", "NaN match.mp4", "Infinity a")) videoNoteOf(text) shouldBe null
    }

    test("a frame of enabling belongs to the first visible enabling, or otherwise to the first of the log") {
        val enabled = listOf(Span(5.0, 20.0), Span(23.0, 158.0))
        enabledStart(enabled, Span(0.0, 200.0)) shouldBe 5.0
        enabledStart(enabled, Span(10.0, 60.0)) shouldBe 23.0
        enabledStart(enabled, Span(170.0, 200.0)) shouldBe 5.0
        enabledStart(emptyList(), Span(0.0, 200.0)) shouldBe null
    }

    test("the hint suggests the frame of enabling only if the log says when the robot was enabled") {
        alignmentHint(hasEnabled = true) shouldContain "“Enabled here”"
        alignmentHint(hasEnabled = false) shouldNotContain "enabled"
    }
})
