package badlog.signals.vocabulary

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class NameWordsSpec : FunSpec({
    test("names are split into words") {
        wordsOf("/Chassis/ActualFrontLeftModule0State/speed") shouldBe listOf("chassis", "actual", "front", "left", "module", "0", "state", "speed")
        wordsOf("CANLoad_max") shouldBe listOf("can", "load", "max")
        wordsOf("Größe/2x") shouldBe listOf("größe", "2", "x")
        wordsOf("") shouldBe emptyList()
    }
})
