package badlog.signals

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly

class ShapeCacheSpec : FunSpec({
    fun viewOf(topic: String, value: Int = 1): LogView {
        val parser = BagParser()
        parser.accept("Time,$topic\n0,$value\n1,$value\n".encodeToByteArray())
        return LogView.of(parser.finish())
    }

    test("all logs of one shape share the prepared result, and only the shape unused for longest is dropped") {
        val made = ArrayList<String>()
        val cache = ShapeCache(max = 2) { shape -> shape.vocabulary.signals.last().name.also { made += it } }
        val names = listOf(viewOf("A"), viewOf("A", value = 2), viewOf("B"), viewOf("A"), viewOf("C"), viewOf("A"), viewOf("B")).map { cache[it] }
        names shouldContainExactly listOf("A", "A", "B", "A", "C", "A", "B")
        made shouldContainExactly listOf("A", "B", "C", "B")
    }
})
