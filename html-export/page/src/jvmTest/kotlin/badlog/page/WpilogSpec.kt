package badlog.page

import badlog.files.gzip
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import org.openqa.selenium.Keys
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Returns four seconds of a robot. They have a number at 50 Hz, one at 10 Hz that ends early, a pose, a state and messages. */
internal fun wpilog(): ByteArray {
    val out = ByteArrayOutputStream()
    fun bytes(size: Int, fill: ByteBuffer.() -> Unit) = out.write(ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN).apply(fill).array())
    fun record(id: Int, micros: Int, size: Int, fill: ByteBuffer.() -> Unit) = bytes(13 + size) { put(0x3F).putInt(id).putInt(size).putInt(micros).fill() }
    fun start(id: Int, name: String, type: String, metadata: String = "") {
        val texts = listOf(name, type, metadata)
        record(0, 0, 5 + texts.sumOf { 4 + it.length }) {
            put(0).putInt(id)
            for (text in texts) putInt(text.length).put(text.encodeToByteArray())
        }
    }
    fun text(id: Int, micros: Int, text: String) = record(id, micros, text.length) { put(text.encodeToByteArray()) }

    bytes(12) { put("WPILOG".encodeToByteArray()).putShort(0x0100).putInt(0) }
    start(1, "/Arm/Angle", "double", "{\"unit\":\"deg\"}")
    start(2, "/Arm/Target", "float")
    start(3, "/Drive/Pose", "struct:Pose")
    start(4, "/.schema/struct:Pose", "structschema")
    start(5, "/Arm/Mode", "string")
    start(6, "messages", "string")
    start(7, "DS:enabled", "boolean")
    text(4, 0, "double x;double y")
    for (i in 0..200) {
        record(1, i * 20_000, 8) { putDouble(if (i < 100) 0.0 else 10.0) }
        if (i < 100 && i % 5 == 0) record(2, i * 20_000, 4) { putFloat(2.5f) }
        record(3, i * 20_000, 16) { putDouble(i / 10.0).putDouble(1.0) }
    }
    text(5, 1_000_000, "hold")
    text(5, 2_000_000, "move")
    text(6, 1_500_000, "ERROR: something happened")
    record(7, 500_000, 1) { put(1) }
    return out.toByteArray()
}

@Tags("InCheck")
internal class WpilogSpec : PageSpec({
    browserTest("a WPILOG opens as a bag does, compressed or not") {
        onPage(TestPages.of(gzip(wpilog()), "run.wpilog.gz")) {
            graphNames shouldContainAll listOf("/Arm/Angle", "/Arm/Target", "/Drive/Pose/x", "/Drive/Pose/y", "/Arm/Mode", "DS:enabled")
            texts(".event .finding-text span") shouldContain "ERROR: something happened"
            texts(".info .value-text") shouldContain "WPILOG: each topic has its own times"
            step("each topic is drawn at its own times, the cursor reads the latest value, and arrow keys go to the next sample of any topic") {
                graph("/Arm/Angle").scrollTo().pixelsOfLine(0) shouldBeGreaterThan 0
                graph("/Arm/Angle").steepest() shouldBe (0.5 plusOrMinus 0.02)
                graph("/Arm/Angle").hover(0.9)
                graph("/Arm/Angle").value("Angle") shouldBe "10"
                graph("/Arm/Target").scrollTo().value("Target") shouldBe "2.5"
                graph("/Arm/Mode").scrollTo().value("Mode") shouldBe "move"
                graph("/Arm/Mode").hover(0.05)
                graph("/Arm/Mode").value("Mode") shouldBe "–"
                graph("/Arm/Angle").scrollTo().hover(0.5)
                val places = List(2) {
                    press(Keys.ARROW_RIGHT)
                    texts(".cursor-readout")[0].removeSuffix(" s").toDouble()
                }
                places[1] - places[0] shouldBe (0.02 plusOrMinus 0.0001)
            }
        }
    }
})
