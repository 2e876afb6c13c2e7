package badlog.viewer.choices

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.set
import io.kotest.property.checkAll

class MergingSpec : FunSpec({
    val items = Arb.set(Arb.int(0..9), 0..8)

    test("additions and removals of two windows are in the list of both, whichever stores it last") {
        checkAll(items, items, items) { read, mine, others ->
            val first = mine.toList().mergedWith(others.toList(), read.toList())
            val second = others.toList().mergedWith(mine.toList(), read.toList())
            first shouldContainExactlyInAnyOrder second
            for (item in 0..9) {
                val isChanged = (item in mine) != (item in read) || (item in others) != (item in read)
                (item in first) shouldBe if (isChanged) item !in read else item in read
            }
        }
    }

    test("a list without changes by others stays the same, in its order") {
        checkAll(100, items, items) { read, mine ->
            val now = mine.toList().reversed()
            now.mergedWith(read.toList(), read.toList()) shouldBe now
        }
    }
})
