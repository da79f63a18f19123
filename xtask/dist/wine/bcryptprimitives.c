// Stands in for the library of Windows of that name, which wine before 9 lacks: what Rust asks it for, random numbers, from one
// that wine has. It is for trying programs here, and is handed on to nobody.
#include <windows.h>

BOOLEAN NTAPI SystemFunction036(PVOID buffer, ULONG length);

__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE buffer, SIZE_T length) { return SystemFunction036(buffer, (ULONG)length); }
