package badlog.viewer.text

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class AmountTextSpec : FunSpec({
    test("counts, sizes and durations are readable") {
        countText(1, "graph") shouldBe "1 graph"
        countText(7500) shouldBe "7500"
        countText(1_000_000) shouldBe "1 000 000"
        countOf(1, 12, "event") shouldBe "1 of 12 events"
        countOf(0, 1, "note") shouldBe "0 of 1 note"
        countOf(12_000, 12_000, "log") shouldBe "12 000 logs"
        bytesText(2_712_345.0) shouldBe "2.7 MB"
        durationText(150.28) shouldBe "2 min 30 s"
        durationText(3600.0) shouldBe "1 h"
        durationText(0.4567) shouldBe "0.46 s"
    }
})
