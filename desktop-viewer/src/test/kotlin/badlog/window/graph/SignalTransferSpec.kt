package badlog.window.graph

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable

class SignalTransferSpec : FunSpec({
    test("signals are dragged as their names, one per line, and files are not signals") {
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
