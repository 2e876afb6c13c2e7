package badlog.networktables.replay

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class OutboxSpec : FunSpec({
    test("each value is sent once and in order") {
        val outbox = Outbox(3, 100)
        repeat(10) { outbox.add(Update(it % 3, it, 0)) }
        outbox.take(0, 4, LongArray(3)).map { it.index } shouldBe listOf(0, 1, 2, 3)
        outbox.take(0, 100, LongArray(3)).map { it.index } shouldBe (4..9).toList()
        outbox.isEmpty shouldBe true
    }

    test("too many values are thinned out, but the last one of each topic is kept") {
        checkAll(Arb.list(Arb.int(0..4), 0..200)) { signals ->
            val outbox = Outbox(5, 20)
            signals.forEachIndexed { index, signal -> outbox.add(Update(signal, index, 0)) }
            val taken = outbox.take(0, 1000, LongArray(5))
            (taken.size <= 20) shouldBe true
            taken.map { it.index } shouldBe taken.map { it.index }.sorted()
            for (signal in 0..4) {
                taken.findLast { it.signal == signal }?.index shouldBe
                    signals.lastIndexOf(signal).takeIf { it >= 0 }
            }
        }
    }

    test("the latest value of a topic with a period is sent when it is due") {
        val outbox = Outbox(1, 100)
        val period = longArrayOf(100)
        outbox.replace(Update(0, 0, 0))
        outbox.replace(Update(0, 1, 0))
        outbox.take(1000, 100, period).map { it.index } shouldBe listOf(1)
        outbox.replace(Update(0, 2, 0))
        outbox.take(1099, 100, period) shouldBe emptyList()
        outbox.take(1100, 100, period).map { it.index } shouldBe listOf(2)
    }

    test("values of topics without a subscription are removed") {
        val outbox = Outbox(2, 100)
        outbox.add(Update(0, 0, 0))
        outbox.replace(Update(1, 0, 0))
        outbox.retain { it == 1 }
        outbox.take(0, 100, LongArray(2)).map { it.signal } shouldBe listOf(1)
    }
})
