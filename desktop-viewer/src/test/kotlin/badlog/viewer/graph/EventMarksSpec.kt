package badlog.viewer.graph

import badlog.analysis.Span
import badlog.viewer.bagOf
import badlog.viewer.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable

class EventMarksSpec : FunSpec({
    fun events(places: List<Double>) = recordingOf(bagOf(listOf("Time|xaxis", "Log|log"), places.map { "$it,at $it" })).events.all

    fun timeline(vararg places: Double) = events(places.toList())

    test("the nearest event is read, if it is near enough") {
        timeline(1.0, 2.0).nearest(1.4, 1.0)?.x shouldBe 1.0
        timeline(1.0, 2.0).nearest(1.6, 1.0)?.x shouldBe 2.0
        timeline(1.0, 2.0).nearest(5.0, 1.0) shouldBe null
        timeline().nearest(5.0, 1.0) shouldBe null
    }

    test("many events cost no more marks than there are pixels") {
        val many = events(List(100_000) { it / 1000.0 })
        many.pixels(Span(0.0, 100.0), 50).size shouldBeLessThanOrEqual 51
        many.pixels(Span(0.0, 100.0), 50).toList().distinct().size shouldBe many.pixels(Span(0.0, 100.0), 50).size
        timeline(1.0, 2.0, 9.0).pixels(Span(0.0, 4.0), 100).toList() shouldBe listOf(25, 50)
    }

    test("signals are dragged as their names, one on a line, and files are none") {
        signalNames(signalTransfer(listOf("A/B", "C, D"))) shouldBe listOf("A/B", "C, D")
        signalNames(StringSelection("")) shouldBe emptyList()
        val files = object : Transferable {
            override fun getTransferDataFlavors() = arrayOf(DataFlavor.javaFileListFlavor)
            override fun isDataFlavorSupported(flavor: DataFlavor) = flavor == DataFlavor.javaFileListFlavor
            override fun getTransferData(flavor: DataFlavor): Any = emptyList<String>()
        }
        signalNames(files) shouldBe emptyList()
    }
})
