package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import java.lang.reflect.Executable
import java.lang.reflect.Member
import java.lang.reflect.Modifier

private const val RELEVANT = Modifier.PUBLIC or Modifier.STATIC

class SignatureSpec : FunSpec({
    test("every public member of the original exists with its erased signature") {
        val list = checkNotNull(SignatureSpec::class.java.getResource("/original-signatures.txt"))
        val wanted = list.readText().trim().lines()
        val classes = wanted.map { it.split(' ')[1] }.distinct().map { Class.forName(it) }
        classes.flatMap(::signaturesOf) shouldContainAll wanted
        // An overload that the original did not have makes method references ambiguous.
        val overloads = { name: String -> BadLog::class.java.methods.count { it.name == name } }
        val creators = listOf("createTopic", "createTopicStr", "createTopicSubscriber", "createValue")
        creators.map(overloads) shouldBe List(4) { 1 }
    }

    test("exceptions are unchecked, and attributes can be given one by one") {
        listOf(DuplicateNameException(), InvalidModeException(), InvalidNameException())
            .map { it.javaClass.superclass } shouldBe List(3) { RuntimeException::class.java }
        BadLog::class.java.methods.filter { it.name.startsWith("createTopic") }.all { it.isVarArgs } shouldBe true
    }
})

private fun signaturesOf(type: Class<*>): List<String> {
    val prefix = "class ${type.name}"
    val fields = type.declaredFields.filter { Modifier.isPublic(it.modifiers) }
        .map { "$prefix ${modifiersOf(it, RELEVANT or Modifier.FINAL)} ${it.type.name} ${it.name}" }
    val methods = type.declaredMethods.map {
        "$prefix ${modifiersOf(it, RELEVANT)} ${it.returnType.typeName} ${it.name}${parametersOf(it)}"
    }
    val constructors = type.constructors.map { "$prefix public ${type.name}${parametersOf(it)}" }
    return listOf(prefix) + fields + methods + constructors
}

private fun modifiersOf(member: Member, relevant: Int) = Modifier.toString(member.modifiers and relevant)

private fun parametersOf(member: Executable) = member.parameterTypes.joinToString(",", "(", ")") { it.typeName }
