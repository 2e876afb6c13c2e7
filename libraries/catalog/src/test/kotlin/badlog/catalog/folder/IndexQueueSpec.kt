package badlog.catalog.folder

import badlog.files.LogFile
import badlog.viewer.catalog.FindingSummary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class IndexQueueSpec : FunSpec({
    fun read(queue: IndexQueue, now: Duration = Duration.ZERO, took: Duration = 10.milliseconds): LogFile? = queue.take()?.also { queue.finished(entry(it.name).copy(source = it), now, took) }

    val old = entry("old.bag", second = 1).source
    val new = entry("new.bag", second = 2).source

    test("the newest file is read first, and none twice") {
        val queue = IndexQueue()
        queue.found(listOf(old, new), Duration.ZERO)
        read(queue) shouldBe new
        queue.found(listOf(old, new), 1.seconds)
        read(queue) shouldBe old
        queue.found(listOf(old, new), 2.seconds)
        read(queue).shouldBeNull()
        queue.state().entries.map { it.source }.toSet() shouldBe setOf(old, new)
    }

    test("a file that is being read is not returned again") {
        val queue = IndexQueue()
        queue.found(listOf(new), Duration.ZERO)
        queue.take() shouldBe new
        queue.found(listOf(new.copy(size = 5000)), 1.seconds)
        queue.take().shouldBeNull()
        queue.state().waiting shouldBe 1
    }

    test("a known file is not read unless it has changed") {
        val queue = IndexQueue { file -> listOf(entry("old.bag", second = 1), entry("new.bag", second = 3), entry("gone.bag")).find { it.source == file } }
        queue.found(listOf(old, new), Duration.ZERO)
        queue.state().entries.map { it.source } shouldContainExactly listOf(old)
        read(queue) shouldBe new
    }

    test("a growing file is read again after a rest that grows with the time it takes") {
        val queue = IndexQueue()
        queue.found(listOf(new), Duration.ZERO)
        read(queue, 1.seconds, took = 1.seconds)
        val grown = new.copy(size = 5000)
        queue.found(listOf(grown), 5.seconds)
        read(queue).shouldBeNull()
        queue.found(listOf(grown), 11.seconds)
        read(queue) shouldBe grown
    }

    test("findings are known until the file changes") {
        val queue = IndexQueue()
        queue.found(listOf(new), Duration.ZERO)
        read(queue)
        val before = queue.state().entries.single()
        queue.searched(before, FindingSummary(1, emptyList()))
        queue.state().entries.single().found shouldBe FindingSummary(1, emptyList())
        val grown = new.copy(size = 5000)
        queue.found(listOf(grown), 20.seconds)
        read(queue) shouldBe grown
        queue.searched(before, FindingSummary(2, emptyList()))
        queue.state().entries.single().found.shouldBeNull()
    }

    test("a deleted file is forgotten, even while it is read") {
        val queue = IndexQueue()
        queue.found(listOf(old, new), Duration.ZERO)
        read(queue)
        val taken = queue.take()!!
        queue.found(emptyList(), 1.seconds)
        queue.finished(entry(taken.name).copy(source = taken), 1.seconds, 1.seconds)
        queue.state().entries.shouldBeEmpty()
        queue.state().waiting shouldBe 0
    }

    test("a skipped file is read when it changes or is requested") {
        val queue = IndexQueue()
        queue.found(listOf(old, new), Duration.ZERO)
        queue.passOverWaiting()
        queue.found(listOf(old, new), 1.seconds)
        queue.take().shouldBeNull()
        queue.state().passedOver shouldBe 2
        queue.found(listOf(old.copy(size = 1), new), 2.seconds)
        read(queue) shouldBe old.copy(size = 1)
        queue.wantAll()
        queue.found(listOf(old.copy(size = 1), new), 3.seconds)
        read(queue) shouldBe new
    }
})
