package badlog.networktables.record

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import kotlin.math.abs

class TimeSyncSpec : FunSpec({
    /** Requests the time at [local] from a server that is [offset] ahead. The message and its answer travel for [there] and [back]. */
    fun TimeSync.ask(local: Long, offset: Long, there: Long = 1000, back: Long = 1000) = answered(local, local + there + offset, local + there + back)

    test("the quickest answer determines the offset") {
        val sync = TimeSync()
        sync.offset shouldBe null
        sync.ask(0, 7_000_000, there = 90_000) shouldBe false
        abs(sync.offset!! - 7_000_000) shouldBe 44_500
        sync.ask(500_000, 7_000_000) shouldBe false
        sync.offset shouldBe 7_000_000
        sync.ask(1_000_000, 7_000_000, back = 150_000) shouldBe false
        sync.offset shouldBe 7_000_000
    }

    test("a drifting clock is followed and never counts as a new one") {
        val sync = TimeSync()
        for (second in 0L..36_000) {
            val drift = second * 50
            sync.ask(second * 1_000_000, 3_000_000 + drift) shouldBe false
            (abs(sync.offset!! - 3_000_000 - drift) <= 3_000) shouldBe true
        }
    }

    test("on a slow network the same clock is recognized, with an error of at most half of the delay") {
        checkAll(Arb.long(-1_000_000_000_000L..1_000_000_000_000L), Arb.list(Arb.int(0..2_000_000), 1..60)) { offset, delays ->
            val sync = TimeSync()
            var local = 0L
            for ((there, back) in delays.chunked(2).map { it.first().toLong() to it.last().toLong() }) {
                sync.ask(local, offset, there, back) shouldBe false
                (abs(sync.offset!! - offset) <= 1_002_000) shouldBe true
                local += 500_000
            }
        }
    }

    test("a restarted clock is noticed, even after a lost connection") {
        val sync = TimeSync()
        sync.ask(0, 5_000_000_000)
        sync.ask(500_000, 0) shouldBe true
        sync.offset shouldBe 0
        sync.disconnected()
        sync.ask(600_000_000, 20_000) shouldBe false
        sync.disconnected()
        sync.ask(900_000_000, -890_000_000) shouldBe true
    }

    test("an answer from before its request is ignored") {
        val sync = TimeSync()
        sync.answered(sent = 100, server = 5, local = 99) shouldBe false
        sync.offset shouldBe null
    }
})
