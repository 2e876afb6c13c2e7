package badlog.window.graph

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class OverviewSpec : FunSpec({
    test("the overview prefers the battery's voltage to the first numbers") {
        overviewSpec(sample("qualification-42.bag"))?.title shouldBe "System/Battery Voltage"
        overviewSpec(recordingOf(bagOf(3) { 1.0 }))?.title shouldBe "A/Voltage"
        overviewSpec(recordingOf("")) shouldBe null
    }
})
