package badlog.fetch

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class BandwidthLimitSpec : FunSpec({
    test("the limit allows its bytes per second, and unused bandwidth is not saved up") {
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

    test("without a limit, no transfer waits") {
        BandwidthLimit(null, { 0 }) { error("waits") }.spend(1_000_000)
    }
})
