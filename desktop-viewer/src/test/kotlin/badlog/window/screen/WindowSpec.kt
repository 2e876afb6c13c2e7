package badlog.window.screen

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.nio.file.Path

class WindowSpec : FunSpec({
    val samples = Path.of("../samples")

    test("a log that is named at the start is shown, and the window closes").config(enabledOrReasonIf = { needsDisplay }) {
        RealWindow(tempdir().toPath(), samples.resolve("qualification-42.bag")).use { window ->
            window.awaitText("Mill Creek Regional Qualification 42")
            window.picture("recording")
        }
    }
})
