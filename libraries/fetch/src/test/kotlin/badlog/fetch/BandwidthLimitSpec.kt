package badlog.fetch

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class BandwidthLimitSpec : FunSpec({
    test("as many bytes come in a second as may, and what was not used is not saved up") {
        var now = 0L
        var slept = 0L
        val limit = BandwidthLimit(2_000_000, { now }) { millis ->
            slept += millis
            now += millis * 1_000_000
        }
        repeat(100) { limit.spend(100_000) }
        slept shouldBe 5000
        now += 60_000_000_000
        repeat(20) { limit.spend(100_000) }
        slept shouldBe 6000
    }

    test("without a limit nothing waits") {
        BandwidthLimit(null, { 0 }) { error("waits") }.spend(1_000_000)
    }
})
