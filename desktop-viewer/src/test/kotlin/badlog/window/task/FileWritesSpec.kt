package badlog.window.task

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import java.io.IOException
import java.util.Collections
import java.util.concurrent.CountDownLatch

class FileWritesSpec : FunSpec({
    test("closing the window writes pending files first, in their order") {
        val writes = FileWrites()
        val written = Collections.synchronizedList(ArrayList<Int>())
        val isClosing = CountDownLatch(1)
        val window = CoroutineScope(Dispatchers.Default)
        for (number in 1..5) {
            window.launch(start = CoroutineStart.UNDISPATCHED) {
                writes.write {
                    isClosing.await()
                    written += number
                }
            }
        }
        window.cancel()
        isClosing.countDown()
        writes.finish { writes.write { written += 6 } }
        written shouldContainExactly listOf(1, 2, 3, 4, 5, 6)
    }

    test("a failed write is reported, and does not affect the others") {
        val writes = FileWrites()
        shouldThrow<IOException> { writes.write { throw IOException("gone") } }
        listOf(writes.write { 1 }) shouldContainExactly listOf(1)
    }
})
