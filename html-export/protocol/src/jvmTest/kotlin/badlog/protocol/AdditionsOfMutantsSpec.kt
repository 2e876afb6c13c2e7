package badlog.protocol

import badlog.core.bag.Mutant
import badlog.core.recording.Value
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

private val MUTANTS = PropertyTesting.defaultIterationCount

class AdditionsOfMutantsSpec : FunSpec({
    test("damaged additions of a page are read as additions or null, without an exception") {
        val hook = HookPart("hook", null, listOf(Value("a", "1")), emptyList(), emptyList(), emptyList())
        val whole = PageAdditions(virtualTopics = listOf("[ a ] = b + 1"), rules = RuleSet.BUILT_IN, hooks = listOf(hook)).toJson()
        PageAdditions.fromJson(whole)?.virtualTopics?.size shouldBe 1
        val random = Random(14)
        repeat(MUTANTS) {
            val mutant = Mutant.of(whole.encodeToByteArray(), random, minOf(whole.length, 2000))
            PageAdditions.fromJson(mutant.bytes.decodeToString())?.toJson()
        }
    }
})
