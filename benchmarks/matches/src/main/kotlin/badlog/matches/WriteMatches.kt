package badlog.matches

fun main() = Unit
