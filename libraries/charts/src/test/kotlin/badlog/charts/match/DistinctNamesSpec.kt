package badlog.charts.match

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly

class DistinctNamesSpec : FunSpec({
    test("names consist of the whole words that topics do not share") {
        distinctNames(listOf("/Drive/LeftTempCelsius", "/Drive/RightTempCelsius")) shouldContainExactly listOf("Left", "Right")
        distinctNames(listOf("Arm/Temperature", "Drive/Front Left/Temperature")) shouldContainExactly listOf("Arm", "Drive/Front Left")
        distinctNames(listOf("Drive/Temperature")) shouldContainExactly listOf("Drive/Temperature")
    }

    test("names are unique, even if they are too long, empty or nearly equal") {
        val long = "x".repeat(200)
        distinctNames(listOf("${long}a", "${long}b")).distinct().size.let { listOf(it) } shouldContainExactly listOf(2)
        distinctNames(listOf("/", "//", "A/")).distinct().size.let { listOf(it) } shouldContainExactly listOf(3)
        distinctNames(emptyList()) shouldContainExactly emptyList()
    }
})
